import"./chunk-chunk-LLMBR4H3.js";
