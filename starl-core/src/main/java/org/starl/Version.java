package org.starl;

/** Which StarL this is. */
public final class Version {

  /** As in the build; a test compares. */
  public static final String STARL = "0.1.0-SNAPSHOT";

  private Version() {}
}
