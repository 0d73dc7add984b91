import"./chunk-chunk-23YNCAWM.js";
