import"./chunk-chunk-W36Q6C2N.js";
