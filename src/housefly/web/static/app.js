import"./chunk-chunk-LOMDLHTK.js";
