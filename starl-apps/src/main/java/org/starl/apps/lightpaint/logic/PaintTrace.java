package org.starl.apps.lightpaint.logic;

/** How one painter appears in a trace: these variables. */
public final class PaintTrace {

  /** {@code source} of the app's events. */
  public static final String SOURCE = "app";

  /** Variable: the {@link Location}. */
  public static final String LOCATION = "location";

  /** Variable: the {@link Light}. */
  public static final String LIGHT = "light";

  /** Variable: the number of the stroke that it is about; -1 for none. */
  public static final String STROKE = "stroke";

  private PaintTrace() {}
}
