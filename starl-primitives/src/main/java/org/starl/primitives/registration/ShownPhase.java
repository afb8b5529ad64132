package org.starl.primitives.registration;

import java.util.List;
import org.starl.primitives.Phases;
import org.starl.primitives.registration.RegistrationProtocol.Phase;

/** The phase of a registration, from its trace: see {@link RegistrationTrace#PHASES}. */
final class ShownPhase implements Phases.Step {

  /** The robot's latest id, as in the text of a view. */
  private String me = "";

  private String view = "";

  @Override
  public String after(String before, String name, List<String> texts) {
    return after(Phase.valueOf(before), name, texts).name();
  }

  private Phase after(Phase phase, String name, List<String> texts) {
    switch (name) {
      case RegistrationTrace.DO_REGISTER -> {
        me = texts.get(0) + "@";
        return Phase.JOINING;
      }
      case RegistrationTrace.UNREGISTER -> {
        return mentions() ? Phase.LEAVING : Phase.OUT;
      }
      case RegistrationTrace.VIEW -> {
        view = texts.get(0);
        return learned(phase);
      }
      case RegistrationTrace.FAILED -> {
        return texts.get(0).equals("true") ? failed(phase) : calledAgain(phase);
      }
      default -> {
        return phase;
      }
    }
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
    int bar = view.indexOf('|');
    return mentions() && (bar < 0 || view.indexOf(me) < bar);
  }

  private boolean mentions() {
    int at = view.indexOf(me);
    return at > 0 && ":,|".indexOf(view.charAt(at - 1)) >= 0;
  }
}
