package org.starl;

/** The version of StarL. */
public final class Version {

  /** Equal to the version in the build, which a test checks. */
  public static final String STARL = "0.1.0-SNAPSHOT";

  private Version() {}
}
