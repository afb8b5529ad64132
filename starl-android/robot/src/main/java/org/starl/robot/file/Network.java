package org.starl.robot.file;

/**
 * How the robots find and hear each other.
 *
 * @param port at which a radio listens unless its robot's address says otherwise, and to which
 *     beacons are broadcast
 * @param broadcasts whether beacons are broadcast on every interface besides going to known addresses
 * @param beaconEveryMs so often a robot says that it is there
 * @param suspectAfterMs who has not been heard for so long is suspected
 * @param loss share of its own datagrams that each robot loses on purpose, to try the app; 0 to 1
 */
public record Network(
    int port, boolean broadcasts, int beaconEveryMs, int suspectAfterMs, double loss) {}
