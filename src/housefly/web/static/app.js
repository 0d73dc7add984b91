import"./chunk-chunk-LRM7EJ3Q.js";
