import"./chunk-chunk-PBMQYSGX.js";
