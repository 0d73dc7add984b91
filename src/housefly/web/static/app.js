import"./chunk-chunk-C2U4MGNN.js";
