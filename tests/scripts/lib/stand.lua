return gr.cube('stand'):scale(4, 0.2, 1):translate(-2, -1.2, -0.5)
