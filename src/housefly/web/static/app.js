import"./chunk-chunk-65J64GUM.js";
