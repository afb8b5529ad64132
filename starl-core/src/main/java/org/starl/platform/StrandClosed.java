package org.starl.platform;

/**
 * Ends an app that waits when its run ends; {@code finally} blocks run. An app must not catch it.
 * It has no stack trace, because it is not an error.
 */
public final class StrandClosed extends RuntimeException {

  private static final long serialVersionUID = 1L;

  public StrandClosed() {
    super("the run has ended", null, false, false);
  }
}
