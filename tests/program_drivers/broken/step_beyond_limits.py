"""It takes a step beyond the limits of its own hello."""

import honest


class Broken(honest.Program):
    moves = "steps"

    def hello(self):
        words = super().hello()
        words["limits"] = {"x": [-0.01, 0.01]}
        return words


Broken().run()
