package org.starl.primitives.registration;

import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.primitives.Phases;
import org.starl.primitives.membership.View;
import org.starl.primitives.registration.RegistrationProtocol.Phase;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/** The phase of a registration, from its trace: see {@link RegistrationFact#PHASES}. */
final class ShownPhase implements Phases.Step {

  /** The robot's latest id. */
  private @Nullable ProcessId me;

  private View view = View.NONE;

  private Phase phase = Phase.OUT;

  @Override
  public String after(String before, TraceEvent event) {
    phase =
        switch (event) {
          case Action action -> acted(action.fact());
          case Variable variable -> changed(variable);
          default -> phase;
        };
    return phase.name();
  }

  private Phase acted(Object fact) {
    return switch (fact) {
      case RegistrationAction.do_register asked -> {
        me = asked.i();
        yield Phase.JOINING;
      }
      case RegistrationAction.unregister left -> mentions() ? Phase.LEAVING : Phase.OUT;
      default -> phase;
    };
  }

  private Phase changed(Variable variable) {
    View learned = variable.of(RegistrationFact.VIEW);
    if (learned != null) {
      view = learned;
      return learned();
    }
    Boolean failed = variable.of(RegistrationFact.FAILED);
    if (failed != null) {
      return failed ? failed() : calledAgain();
    }
    return phase;
  }

  private Phase learned() {
    return switch (phase) {
      case JOINING -> lists() ? Phase.IN : phase;
      case IN -> lists() ? phase : Phase.OUT;
      case LEAVING, LEFT_HALFWAY -> mentions() ? phase : Phase.OUT;
      case OUT -> phase;
    };
  }

  private Phase failed() {
    return phase == Phase.LEAVING ? Phase.LEFT_HALFWAY : Phase.OUT;
  }

  /** A repeated {@code unregister} is no action of the trace. */
  private Phase calledAgain() {
    return phase == Phase.LEFT_HALFWAY ? Phase.LEAVING : phase;
  }

  private boolean lists() {
    return me != null && view.contains(me);
  }

  private boolean mentions() {
    return me != null && view.mentions(me);
  }
}
