package org.starl.robot.file;

/**
 * How the robots find and hear each other.
 *
 * @param port UDP port of the broadcast beacons, and of each robot whose address has no port
 * @param broadcasts whether beacons are broadcast on every interface as well as sent to known addresses
 * @param beaconEveryMs time between two beacons of a robot
 * @param suspectAfterMs a robot that was not heard for this time is suspected
 * @param loss fraction of its own datagrams that each robot drops on purpose, to test the app; 0 to 1
 */
public record Network(
    int port, boolean broadcasts, int beaconEveryMs, int suspectAfterMs, double loss) {}
