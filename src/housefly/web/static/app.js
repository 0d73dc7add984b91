import"./chunk-chunk-PVYBGDIB.js";
