"""Its hello has an axis that does not exist."""

import honest


class Broken(honest.Program):
    def hello(self):
        return dict(super().hello(), axes=["x", "y", "w"])


Broken().run()
