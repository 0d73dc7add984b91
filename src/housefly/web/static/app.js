import"./chunk-chunk-Z2KIFKF6.js";
