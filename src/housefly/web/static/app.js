import"./chunk-chunk-VUDHG5OW.js";
