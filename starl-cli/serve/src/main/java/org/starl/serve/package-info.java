/**
 * The server of {@code starl serve}, on Javalin: pages of runs, their parts as server-sent events, and
 * Foxglove's WebSocket protocol. The command line finds it as a service.
 *
 * <p>Contract: a request whose {@code Host} or {@code Origin} is foreign is refused, and beyond this
 * machine each needs the token. A connection never delays a run: it reads what is recorded.
 *
 * <p>May import: all other modules; no module imports it.
 */
@NullMarked
package org.starl.serve;

import org.jspecify.annotations.NullMarked;
