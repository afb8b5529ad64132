package org.starl.comms;

/** A pending reliable message: the datagram to retransmit, and what the trace records. */
record RetainedMessage(OpenEndpoint<?> endpoint, Object message, long number, byte[] datagram) {}
