import"./chunk-chunk-XA4URJ4Y.js";
