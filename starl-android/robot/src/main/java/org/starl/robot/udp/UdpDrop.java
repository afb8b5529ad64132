package org.starl.robot.udp;

/** Why a radio dropped a received datagram before handing it to the robot. */
public enum UdpDrop {
  FOREIGN("not from a robot's address"),
  OVERSIZE("longer than any StarL datagram"),
  OVERFLOW("the robot's strand is too far behind"),
  FORGED_BEACON("a beacon that the robot it names has not signed"),
  UNKNOWN_KEY_BEACON("a beacon signed with a key that this deployment does not list"),
  UNPROVEN_BEACON("a beacon that does not prove that it is not a recording"),
  PASSED_ON_BEACON("a beacon that names another source address"),
  STRANGE_BEACON("a beacon from a robot that is not in the deployment"),
  UNEXPECTED_BEACON("a beacon before discovery has started"),
  OLD_BEACON("a beacon that is not newer than the last one"),
  OWN_BEACON("this robot's own beacon");

  private final String description;

  UdpDrop(String description) {
    this.description = description;
  }

  /** Whether it cannot occur in a network of correct robots. */
  boolean isSuspicious() {
    return this != UNEXPECTED_BEACON
        && this != UNPROVEN_BEACON
        && this != OLD_BEACON
        && this != OWN_BEACON;
  }

  /** For people. */
  String description() {
    return description;
  }
}
