import"./chunk-chunk-NS7N3RH6.js";
