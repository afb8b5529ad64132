package org.starl.cli.campaign;

import org.starl.sim.explore.Explored;

/**
 * What an exploration keeps of one schedule, as a row of a shard.
 *
 * @param key a digest of version, app, settings and bounds
 */
record ScheduleRow(String key, Explored explored) {}
