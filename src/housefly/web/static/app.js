import"./chunk-chunk-RLB4HYAH.js";
