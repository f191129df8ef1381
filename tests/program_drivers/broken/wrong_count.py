"""It tells fewer positions than it has axes."""

import honest


class Broken(honest.Program):
    def state(self):
        state = super().state()
        state["position"] = state["position"][:-1]
        return state


Broken().run()
