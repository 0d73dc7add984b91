import"./chunk-chunk-EAI2IBFR.js";
