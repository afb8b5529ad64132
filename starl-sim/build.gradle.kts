plugins {
    `java-library`
    id("maven-publish")
}

description = "Platform and physical layers, simulated"

dependencies {
    api(project(":starl-core"))
    api(libs.jspecify)
    implementation(libs.jackson.databind)
    implementation(libs.flatlaf)
    // For users' tests alone: who runs simulations elsewhere does not have it.
    compileOnly(libs.junit.jupiter.api)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.junit.platform.testkit)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}
