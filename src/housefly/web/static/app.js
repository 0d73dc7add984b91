import"./chunk-chunk-Y5CURCGG.js";
