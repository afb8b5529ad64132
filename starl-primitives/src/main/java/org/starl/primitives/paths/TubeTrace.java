package org.starl.primitives.paths;

import java.util.List;
import org.starl.primitives.Phases;

/** The names of tubes in the trace; {@link TubesSpec} reads them. */
public final class TubeTrace {

  static final String PRIMITIVE = "tubes";
  static final String HELD = "held";
  static final String FLAG = "tubeflag";
  static final String FAILURE = "failure";
  static final String GO_TO = "goTo";

  /** The phases are the values of {@link TubeFlag}. */
  public static final Phases PHASES =
      Phases.of(PRIMITIVE, TubeMessage.class, () -> TubeTrace::phase, (Object[]) TubeFlag.values());

  private TubeTrace() {}

  private static String phase(String before, String name, List<String> texts) {
    return name.equals(FLAG) ? texts.get(0) : before;
  }

  static boolean isTubes(String source) {
    return source.startsWith(PRIMITIVE + "/");
  }
}
