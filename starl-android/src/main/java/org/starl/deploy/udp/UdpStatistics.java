package org.starl.deploy.udp;

/**
 * What a radio has sent and heard.
 *
 * @param sent datagrams given to the network, one for each recipient
 * @param unsent those that had no known recipient, or that the network refused
 * @param received datagrams handed to the strand
 * @param foreign dropped: not from a peer's address
 * @param oversize dropped: longer than any datagram of ours
 * @param overflow dropped: the strand was too far behind
 */
public record UdpStatistics(
    long sent, long unsent, long received, long foreign, long oversize, long overflow) {}
