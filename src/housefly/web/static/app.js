import"./chunk-chunk-47SXU5KT.js";
