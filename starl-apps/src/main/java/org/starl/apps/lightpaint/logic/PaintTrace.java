package org.starl.apps.lightpaint.logic;

import org.starl.trace.TraceEvent;

/** The variables of a painter in the trace. */
public final class PaintTrace {

  /** {@code source} of the variables. */
  public static final String SOURCE = "app";

  /** Variable: the {@link Location}. */
  public static final String LOCATION = "location";

  /** Variable: the {@link Light}. */
  public static final String LIGHT = "light";

  /** Variable: the number of the stroke that it works on; -1 for none. */
  public static final String STROKE = "stroke";

  private PaintTrace() {}

  /** Whether {@code variable} is the painter's variable of this name. */
  public static boolean is(TraceEvent.Variable variable, String name) {
    return variable.source().equals(SOURCE) && variable.name().equals(name);
  }
}
