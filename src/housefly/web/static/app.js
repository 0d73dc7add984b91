import"./chunk-chunk-XEKIM5MM.js";
