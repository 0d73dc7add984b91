import"./chunk-chunk-QAUQUBDC.js";
