import"./chunk-chunk-GL7F7VKU.js";
