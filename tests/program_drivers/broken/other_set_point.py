"""It tells another set point than the one that it was given."""

import honest


class Broken(honest.Program):
    def state(self):
        state = super().state()
        return dict(state, set_point=0.5 * state["set_point"])


Broken().run()
