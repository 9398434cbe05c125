"""What a picture is made of, before anything is written: items, labels, legend, layout."""
