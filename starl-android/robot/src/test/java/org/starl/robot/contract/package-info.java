/**
 * What every implementation of a port must do: one abstract test a port, run against the simulated
 * and the real one. A new implementation extends the contract of its port, and gives it its {@link
 * org.starl.robot.contract.Ground}.
 */
package org.starl.robot.contract;
