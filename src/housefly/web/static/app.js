import"./chunk-chunk-TQB6S7LY.js";
