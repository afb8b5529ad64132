package org.starl.robot.udp;

/** Why a radio has dropped a datagram that came, before anybody looked into it. */
public enum UdpDrop {
  FOREIGN("not from a robot's address"),
  OVERSIZE("longer than any datagram of ours"),
  OVERFLOW("the robot's strand is too far behind"),
  FORGED_BEACON("a beacon that the deployment's key has not signed"),
  PASSED_ON_BEACON("a beacon that does not come from where it says"),
  STRANGE_BEACON("a beacon of a robot that this deployment does not have"),
  UNEXPECTED_BEACON("a beacon, which nobody here looks for yet"),
  OLD_BEACON("a beacon that was heard before, or a newer one was"),
  OWN_BEACON("this robot's own beacon");

  private final String what;

  UdpDrop(String what) {
    this.what = what;
  }

  /** Whether a network of well-behaved robots never shows it. */
  boolean isSuspicious() {
    return this != UNEXPECTED_BEACON && this != OLD_BEACON && this != OWN_BEACON;
  }

  /** For people. */
  String what() {
    return what;
  }
}
