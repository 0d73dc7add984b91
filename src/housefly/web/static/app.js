import"./chunk-chunk-3DXL52OW.js";
