package org.starl.primitives.paths;

/** The names of tubes in the trace; {@link TubesSpec} reads them. */
final class TubeTrace {

  static final String PRIMITIVE = "tubes";
  static final String HELD = "held";
  static final String FLAG = "tubeflag";
  static final String FAILURE = "failure";
  static final String GO_TO = "goTo";

  private TubeTrace() {}

  static boolean isTubes(String source) {
    return source.startsWith(PRIMITIVE + "/");
  }
}
