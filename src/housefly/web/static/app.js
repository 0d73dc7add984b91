import"./chunk-chunk-ZTHLB2H7.js";
