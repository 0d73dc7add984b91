import"./chunk-chunk-UIBBPBF6.js";
