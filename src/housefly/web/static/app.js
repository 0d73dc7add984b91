import"./chunk-chunk-X2RRVNL4.js";
