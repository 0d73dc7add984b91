import"./chunk-chunk-2NQ4O4SZ.js";
