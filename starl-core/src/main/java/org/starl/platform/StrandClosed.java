package org.starl.platform;

/**
 * Unwinds an app that waits when its run ends, {@code finally} blocks included. An app does not
 * catch it. It carries no stack trace: it is no error.
 */
public final class StrandClosed extends RuntimeException {

  private static final long serialVersionUID = 1L;

  public StrandClosed() {
    super("the run has ended", null, false, false);
  }
}
