import"./chunk-chunk-UHCQRQJK.js";
