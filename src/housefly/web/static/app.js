import"./chunk-chunk-X3AT55XI.js";
