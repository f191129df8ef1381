"""Its hello has no name."""

import honest


class Broken(honest.Program):
    def hello(self):
        words = super().hello()
        del words["name"]
        return words


Broken().run()
