import"./chunk-chunk-GY776DSV.js";
