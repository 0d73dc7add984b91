import"./chunk-chunk-AHIWV3RZ.js";
