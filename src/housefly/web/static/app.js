import"./chunk-chunk-E3X2DXY6.js";
