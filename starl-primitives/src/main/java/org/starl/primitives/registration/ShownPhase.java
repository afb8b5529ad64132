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

  @Override
  public String after(String before, TraceEvent event) {
    Phase phase = Phase.valueOf(before);
    return switch (event) {
      case Action action -> acted(phase, action.fact()).name();
      case Variable variable -> changed(phase, variable).name();
      default -> before;
    };
  }

  private Phase acted(Phase phase, Object fact) {
    return switch (fact) {
      case RegistrationAction.do_register asked -> {
        me = asked.i();
        yield Phase.JOINING;
      }
      case RegistrationAction.unregister left -> mentions() ? Phase.LEAVING : Phase.OUT;
      default -> phase;
    };
  }

  private Phase changed(Phase phase, Variable variable) {
    View learned = variable.of(RegistrationFact.VIEW);
    if (learned != null) {
      view = learned;
      return learned(phase);
    }
    Boolean failed = variable.of(RegistrationFact.FAILED);
    if (failed != null) {
      return failed ? failed(phase) : calledAgain(phase);
    }
    return phase;
  }

  private Phase learned(Phase phase) {
    return switch (phase) {
      case JOINING -> lists() ? Phase.IN : phase;
      case IN -> lists() ? phase : Phase.OUT;
      case LEAVING, LEFT_HALFWAY -> mentions() ? phase : Phase.OUT;
      case OUT -> phase;
    };
  }

  private static Phase failed(Phase phase) {
    return phase == Phase.LEAVING ? Phase.LEFT_HALFWAY : Phase.OUT;
  }

  /** A repeated {@code unregister} is no action of the trace. */
  private static Phase calledAgain(Phase phase) {
    return phase == Phase.LEFT_HALFWAY ? Phase.LEAVING : phase;
  }

  private boolean lists() {
    return me != null && view.contains(me);
  }

  private boolean mentions() {
    return me != null && view.mentions(me);
  }
}
