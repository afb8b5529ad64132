package org.starl.sim.kernel;

/**
 * Virtual time stands still: one robot, or the world, acts again and again at one virtual time, or
 * one action does not end. The stack trace is that of the code that goes on.
 */
public final class Stalled extends IllegalStateException {

  private static final long serialVersionUID = 1L;

  private static final String ADVICE =
      ": virtual time stands still; a loop needs a sleep(ms) above 0 ms, or an await of a condition"
          + " that does not hold yet";

  private Stalled(String what) {
    super(what);
  }

  static Stalled awaits(int awaits) {
    return new Stalled(awaits + " awaits in one action, whose conditions held at once" + ADVICE);
  }

  static Stalled actions(int actions) {
    return new Stalled(actions + " actions at one virtual time" + ADVICE);
  }

  static Stalled world(int events) {
    return new Stalled(
        events
            + " events of the world at one virtual time: a bug of the simulator, or of a"
            + " director or fault that schedules without end");
  }

  /** An action that has used {@code cpuSeconds} of processor time, with the stack where it is. */
  static Stalled action(long cpuSeconds, StackTraceElement[] stack) {
    Stalled stalled =
        new Stalled(
            "one action has used " + cpuSeconds + " s of processor time and does not end" + ADVICE);
    stalled.setStackTrace(stack);
    return stalled;
  }
}
