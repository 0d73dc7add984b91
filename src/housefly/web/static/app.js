import"./chunk-chunk-QJ26BLB4.js";
