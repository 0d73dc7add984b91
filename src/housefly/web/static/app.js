import"./chunk-chunk-IV6KK5BE.js";
