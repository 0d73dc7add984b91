import"./chunk-chunk-GBZITIIU.js";
