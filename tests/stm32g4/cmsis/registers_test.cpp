// Our names of registers, bits and places against those of ST's header for the device.
#include "firmware/boards/b_g431b_esc1/registers.hpp"

#include <gtest/gtest.h>

#include <cstddef>

// Last: its macros have short names.
#include <stm32g431xx.h>

namespace {

using namespace hal::stm32g4;
namespace addresses = boards::b_g431b_esc1::registers::addresses;

constexpr std::uint32_t all_but(std::uint64_t mask) {
  return ~static_cast<std::uint32_t>(mask);
}

#define SAME(ours, st) EXPECT_EQ(std::uint64_t{ours}, std::uint64_t{st}) << #ours " is not " #st
#define SAME_PLACE(File, member, Struct, MEMBER) \
  EXPECT_EQ(offsetof(File<Register>, member), offsetof(Struct, MEMBER)) << #Struct "." #MEMBER

TEST(RegistersOfSt, Clocks) {
  SAME(rcc::kHsi16On, RCC_CR_HSION);
  SAME(rcc::kHsi16Ready, RCC_CR_HSIRDY);
  SAME(rcc::kHseOn, RCC_CR_HSEON);
  SAME(rcc::kHseReady, RCC_CR_HSERDY);
  SAME(rcc::kCssOn, RCC_CR_CSSON);
  SAME(rcc::kPllOn, RCC_CR_PLLON);
  SAME(rcc::kPllReady, RCC_CR_PLLRDY);
  SAME(rcc::kSwitchMask, RCC_CFGR_SW);
  SAME(rcc::kSwitchPll, RCC_CFGR_SW_PLL);
  SAME(rcc::kSwitchHsi16, RCC_CFGR_SW_HSI);
  SAME(rcc::kSwitchStatusMask, RCC_CFGR_SWS);
  SAME(rcc::kSwitchStatusPll, RCC_CFGR_SWS_PLL);
  SAME(rcc::kSwitchStatusHsi16, RCC_CFGR_SWS_HSI);
  SAME(rcc::kHclkMask, RCC_CFGR_HPRE);
  SAME(rcc::kHclkBy2, RCC_CFGR_HPRE_DIV2);
  SAME(rcc::kPllSourceHsi16, RCC_PLLCFGR_PLLSRC_HSI);
  SAME(rcc::kPllSourceHse, RCC_PLLCFGR_PLLSRC_HSE);
  SAME(rcc::pll_m(16), RCC_PLLCFGR_PLLM);
  SAME(rcc::pll_n(127), RCC_PLLCFGR_PLLN);
  SAME(rcc::kPllREnable, RCC_PLLCFGR_PLLREN);
  SAME(rcc::kCssFlag, RCC_CIFR_CSSF);
  SAME(rcc::kGpioA, RCC_AHB2ENR_GPIOAEN);
  SAME(rcc::kGpioB, RCC_AHB2ENR_GPIOBEN);
  SAME(rcc::kGpioC, RCC_AHB2ENR_GPIOCEN);
  SAME(rcc::kAdc12, RCC_AHB2ENR_ADC12EN);
  SAME(rcc::kRng, RCC_AHB2ENR_RNGEN);
  SAME(rcc::kTim2, RCC_APB1ENR1_TIM2EN);
  SAME(rcc::kFdcan, RCC_APB1ENR1_FDCANEN);
  SAME(rcc::kPwr, RCC_APB1ENR1_PWREN);
  SAME(rcc::kSyscfg, RCC_APB2ENR_SYSCFGEN);
  SAME(rcc::kTim1, RCC_APB2ENR_TIM1EN);
  SAME(rcc::kFdcanMask, RCC_CCIPR_FDCANSEL);
  SAME(rcc::kFdcanPclk1, RCC_CCIPR_FDCANSEL_1);
  SAME(rcc::kClk48Mask, RCC_CCIPR_CLK48SEL);
  SAME(rcc::kRemoveResetFlags, RCC_CSR_RMVF);
  SAME(rcc::kWatchdogReset, RCC_CSR_IWDGRSTF);
  SAME(rcc::kHsi48On, RCC_CRRCR_HSI48ON);
  SAME(rcc::kHsi48Ready, RCC_CRRCR_HSI48RDY);
  SAME(pwr::kVoltageMask, PWR_CR1_VOS);
  SAME(pwr::kVoltageRange1, PWR_CR1_VOS_0);
  SAME(pwr::kNoDeadBattery, PWR_CR3_UCPD_DBDIS);
  SAME(pwr::kVoltageChanging, PWR_SR2_VOSF);
  SAME(pwr::kRange1NotBoosted, PWR_CR5_R1MODE);
}

TEST(RegistersOfSt, Flash) {
  SAME(flash::kLatencyMask, FLASH_ACR_LATENCY);
  SAME(flash::kLatency4, FLASH_ACR_LATENCY_4WS);
  SAME(flash::kPrefetch, FLASH_ACR_PRFTEN);
  SAME(flash::kInstructionCache, FLASH_ACR_ICEN);
  SAME(flash::kDataCache, FLASH_ACR_DCEN);
  SAME(flash::kDataCacheReset, FLASH_ACR_DCRST);
  SAME(flash::kEndOfOperation, FLASH_SR_EOP);
  SAME(flash::kOperationError, FLASH_SR_OPERR);
  SAME(flash::kProgramError, FLASH_SR_PROGERR);
  SAME(flash::kWriteProtected, FLASH_SR_WRPERR);
  SAME(flash::kAlignmentError, FLASH_SR_PGAERR);
  SAME(flash::kSizeError, FLASH_SR_SIZERR);
  SAME(flash::kSequenceError, FLASH_SR_PGSERR);
  SAME(flash::kMissError, FLASH_SR_MISERR);
  SAME(flash::kFastError, FLASH_SR_FASTERR);
  SAME(flash::kReadProtected, FLASH_SR_RDERR);
  SAME(flash::kOptionError, FLASH_SR_OPTVERR);
  SAME(flash::kBusy, FLASH_SR_BSY);
  SAME(flash::kProgram, FLASH_CR_PG);
  SAME(flash::kPageErase, FLASH_CR_PER);
  SAME(flash::kStart, FLASH_CR_STRT);
  SAME(flash::kLock, FLASH_CR_LOCK);
  SAME(flash::page(63), FLASH_CR_PNB);
  SAME(flash::kEccInterrupt, FLASH_ECCR_ECCIE);
  SAME(flash::kEccCorrected, FLASH_ECCR_ECCC);
  SAME(flash::kEccDetected, FLASH_ECCR_ECCD);
}

TEST(RegistersOfSt, Analog) {
  SAME(opamp::kEnable, OPAMP_CSR_OPAMPxEN);
  SAME(opamp::kProgrammableGain, OPAMP_CSR_VMSEL_1);
  SAME(opamp::kHighSpeed, OPAMP_CSR_HIGHSPEEDEN);
  SAME(opamp::kInternalOutput, OPAMP_CSR_OPAMPINTEN);
  SAME(opamp::kGain16BiasOnInput0, (OPAMP_CSR_PGGAIN_0 | OPAMP_CSR_PGGAIN_1 | OPAMP_CSR_PGGAIN_3));
  SAME(adc::kReady, ADC_ISR_ADRDY);
  SAME(adc::kInjectedEnd, ADC_ISR_JEOC);
  SAME(adc::kInjectedSequence, ADC_ISR_JEOS);
  SAME(adc::kInjectedSequenceInterrupt, ADC_IER_JEOSIE);
  SAME(adc::kEnable, ADC_CR_ADEN);
  SAME(adc::kInjectedStart, ADC_CR_JADSTART);
  SAME(adc::kRegulator, ADC_CR_ADVREGEN);
  SAME(adc::kDeepPowerDown, ADC_CR_DEEPPWD);
  SAME(adc::kCalibrateDifferential, ADC_CR_ADCALDIF);
  SAME(adc::kCalibrate, ADC_CR_ADCAL);
  SAME(adc::kSetOnly, (ADC_CR_ADEN | ADC_CR_ADDIS | ADC_CR_ADSTART | ADC_CR_JADSTART |
                       ADC_CR_ADSTP | ADC_CR_JADSTP | ADC_CR_ADCAL));
  SAME(adc::kNoInjectedQueue, ADC_CFGR_JQDIS);
  SAME(adc::sample_24_5_cycles(13), (ADC_SMPR2_SMP13_0 | ADC_SMPR2_SMP13_1));
  SAME(adc::sample_24_5_cycles(16), (ADC_SMPR2_SMP16_0 | ADC_SMPR2_SMP16_1));
  SAME(adc::sample_24_5_cycles(18), (ADC_SMPR2_SMP18_0 | ADC_SMPR2_SMP18_1));
  SAME(adc::injected_length(4), ADC_JSQR_JL);
  SAME(adc::injected_channel(1, 31), ADC_JSQR_JSQ1);
  SAME(adc::injected_channel(2, 31), ADC_JSQR_JSQ2);
  SAME(adc::kTriggerTim1Trgo2, ADC_JSQR_JEXTSEL_3);
  SAME(adc::kRisingEdge, ADC_JSQR_JEXTEN_0);
  SAME(adc::kClockModeMask, ADC_CCR_CKMODE);
  SAME(adc::kHclkBy4, (ADC_CCR_CKMODE_0 | ADC_CCR_CKMODE_1));
}

TEST(RegistersOfSt, Can) {
  SAME(fdcan::kInit, FDCAN_CCCR_INIT);
  SAME(fdcan::kConfigure, FDCAN_CCCR_CCE);
  SAME(fdcan::bit_timing(512, 1, 1, 1), FDCAN_NBTP_NBRP);
  SAME(fdcan::bit_timing(1, 256, 1, 1), FDCAN_NBTP_NTSEG1);
  SAME(fdcan::bit_timing(1, 1, 128, 1), FDCAN_NBTP_NTSEG2);
  SAME(fdcan::bit_timing(1, 1, 1, 128), FDCAN_NBTP_NSJW);
  SAME(fdcan::kReceivePassive, FDCAN_ECR_RP);
  SAME(fdcan::transmit_errors(FDCAN_ECR_TEC), 0xFFu);
  SAME(fdcan::transmit_errors(all_but(FDCAN_ECR_TEC)), 0u);
  SAME(fdcan::receive_errors(FDCAN_ECR_REC), 0x7Fu);
  SAME(fdcan::receive_errors(all_but(FDCAN_ECR_REC)), 0u);
  SAME(fdcan::kPassive, FDCAN_PSR_EP);
  SAME(fdcan::kWarning, FDCAN_PSR_EW);
  SAME(fdcan::kBusOff, FDCAN_PSR_BO);
  SAME(fdcan::kFifo0Lost, FDCAN_IR_RF0L);
  SAME(fdcan::kRejectRemoteExtended, FDCAN_RXGFC_RRFE);
  SAME(fdcan::kRejectRemoteStandard, FDCAN_RXGFC_RRFS);
  SAME(fdcan::kRejectOtherExtended, 2u << FDCAN_RXGFC_ANFE_Pos);
  SAME(fdcan::kRejectOtherStandard, 2u << FDCAN_RXGFC_ANFS_Pos);
  SAME(fdcan::filters(31, 0), FDCAN_RXGFC_LSS);
  SAME(fdcan::filters(0, 15), FDCAN_RXGFC_LSE);
  SAME(fdcan::fill_level(FDCAN_RXF0S_F0FL), 0xFu);
  SAME(fdcan::fill_level(all_but(FDCAN_RXF0S_F0FL)), 0u);
  SAME(fdcan::get_index(FDCAN_RXF0S_F0GI), 3u);
  SAME(fdcan::get_index(all_but(FDCAN_RXF0S_F0GI)), 0u);
  SAME(fdcan::kTransmitFull, FDCAN_TXFQS_TFQF);
  SAME(fdcan::put_index(FDCAN_TXFQS_TFQPI), 3u);
  SAME(fdcan::put_index(all_but(FDCAN_TXFQS_TFQPI)), 0u);
}

TEST(RegistersOfSt, TimersAndOthers) {
  SAME(tim::kEnable, TIM_CR1_CEN);
  SAME(tim::kCentreAligned1, TIM_CR1_CMS_0);
  SAME(tim::kTrgo2Oc4Ref, (TIM_CR2_MMS2_0 | TIM_CR2_MMS2_1 | TIM_CR2_MMS2_2));
  SAME(tim::kUpdate, TIM_EGR_UG);
  SAME(tim::kOc4PwmMode2, (TIM_CCMR2_OC4M_0 | TIM_CCMR2_OC4M_1 | TIM_CCMR2_OC4M_2));
  SAME(rng::kEnable, RNG_CR_RNGEN);
  SAME(rng::kReady, RNG_SR_DRDY);
  SAME(rng::kClockNow, RNG_SR_CECS);
  SAME(rng::kSeedNow, RNG_SR_SECS);
  SAME(rng::kClockError, RNG_SR_CEIS);
  SAME(rng::kSeedError, RNG_SR_SEIS);
  SAME(iwdg::kDivideBy32, (IWDG_PR_PR_0 | IWDG_PR_PR_1));
  SAME(kAdc12Interrupt, static_cast<unsigned>(ADC1_2_IRQn));
  SAME(kInterrupts, static_cast<unsigned>(FMAC_IRQn) + 1);
}

TEST(RegistersOfSt, Places) {
  SAME_PLACE(RccRegisters, cr, RCC_TypeDef, CR);
  SAME_PLACE(RccRegisters, icscr, RCC_TypeDef, ICSCR);
  SAME_PLACE(RccRegisters, cfgr, RCC_TypeDef, CFGR);
  SAME_PLACE(RccRegisters, pllcfgr, RCC_TypeDef, PLLCFGR);
  SAME_PLACE(RccRegisters, cier, RCC_TypeDef, CIER);
  SAME_PLACE(RccRegisters, cifr, RCC_TypeDef, CIFR);
  SAME_PLACE(RccRegisters, cicr, RCC_TypeDef, CICR);
  SAME_PLACE(RccRegisters, ahb1enr, RCC_TypeDef, AHB1ENR);
  SAME_PLACE(RccRegisters, ahb2enr, RCC_TypeDef, AHB2ENR);
  SAME_PLACE(RccRegisters, apb1enr1, RCC_TypeDef, APB1ENR1);
  SAME_PLACE(RccRegisters, apb2enr, RCC_TypeDef, APB2ENR);
  SAME_PLACE(RccRegisters, ccipr, RCC_TypeDef, CCIPR);
  SAME_PLACE(RccRegisters, bdcr, RCC_TypeDef, BDCR);
  SAME_PLACE(RccRegisters, csr, RCC_TypeDef, CSR);
  SAME_PLACE(RccRegisters, crrcr, RCC_TypeDef, CRRCR);
  SAME_PLACE(RccRegisters, ccipr2, RCC_TypeDef, CCIPR2);
  SAME_PLACE(PwrRegisters, cr1, PWR_TypeDef, CR1);
  SAME_PLACE(PwrRegisters, cr3, PWR_TypeDef, CR3);
  SAME_PLACE(PwrRegisters, sr1, PWR_TypeDef, SR1);
  SAME_PLACE(PwrRegisters, sr2, PWR_TypeDef, SR2);
  SAME_PLACE(PwrRegisters, scr, PWR_TypeDef, SCR);
  SAME_PLACE(PwrRegisters, pull, PWR_TypeDef, PUCRA);
  SAME_PLACE(PwrRegisters, cr5, PWR_TypeDef, CR5);
  SAME_PLACE(FlashRegisters, acr, FLASH_TypeDef, ACR);
  SAME_PLACE(FlashRegisters, pdkeyr, FLASH_TypeDef, PDKEYR);
  SAME_PLACE(FlashRegisters, keyr, FLASH_TypeDef, KEYR);
  SAME_PLACE(FlashRegisters, optkeyr, FLASH_TypeDef, OPTKEYR);
  SAME_PLACE(FlashRegisters, sr, FLASH_TypeDef, SR);
  SAME_PLACE(FlashRegisters, cr, FLASH_TypeDef, CR);
  SAME_PLACE(FlashRegisters, eccr, FLASH_TypeDef, ECCR);
  SAME_PLACE(FlashRegisters, optr, FLASH_TypeDef, OPTR);
  SAME_PLACE(GpioRegisters, moder, GPIO_TypeDef, MODER);
  SAME_PLACE(GpioRegisters, otyper, GPIO_TypeDef, OTYPER);
  SAME_PLACE(GpioRegisters, ospeedr, GPIO_TypeDef, OSPEEDR);
  SAME_PLACE(GpioRegisters, pupdr, GPIO_TypeDef, PUPDR);
  SAME_PLACE(GpioRegisters, idr, GPIO_TypeDef, IDR);
  SAME_PLACE(GpioRegisters, odr, GPIO_TypeDef, ODR);
  SAME_PLACE(GpioRegisters, bsrr, GPIO_TypeDef, BSRR);
  SAME_PLACE(GpioRegisters, lckr, GPIO_TypeDef, LCKR);
  SAME_PLACE(GpioRegisters, afr, GPIO_TypeDef, AFR);
  SAME_PLACE(GpioRegisters, brr, GPIO_TypeDef, BRR);
  SAME_PLACE(TimRegisters, cr1, TIM_TypeDef, CR1);
  SAME_PLACE(TimRegisters, cr2, TIM_TypeDef, CR2);
  SAME_PLACE(TimRegisters, smcr, TIM_TypeDef, SMCR);
  SAME_PLACE(TimRegisters, dier, TIM_TypeDef, DIER);
  SAME_PLACE(TimRegisters, sr, TIM_TypeDef, SR);
  SAME_PLACE(TimRegisters, egr, TIM_TypeDef, EGR);
  SAME_PLACE(TimRegisters, ccmr1, TIM_TypeDef, CCMR1);
  SAME_PLACE(TimRegisters, ccmr2, TIM_TypeDef, CCMR2);
  SAME_PLACE(TimRegisters, ccer, TIM_TypeDef, CCER);
  SAME_PLACE(TimRegisters, cnt, TIM_TypeDef, CNT);
  SAME_PLACE(TimRegisters, psc, TIM_TypeDef, PSC);
  SAME_PLACE(TimRegisters, arr, TIM_TypeDef, ARR);
  SAME_PLACE(TimRegisters, rcr, TIM_TypeDef, RCR);
  SAME_PLACE(TimRegisters, ccr, TIM_TypeDef, CCR1);
  SAME_PLACE(TimRegisters, bdtr, TIM_TypeDef, BDTR);
  SAME_PLACE(AdcRegisters, isr, ADC_TypeDef, ISR);
  SAME_PLACE(AdcRegisters, ier, ADC_TypeDef, IER);
  SAME_PLACE(AdcRegisters, cr, ADC_TypeDef, CR);
  SAME_PLACE(AdcRegisters, cfgr, ADC_TypeDef, CFGR);
  SAME_PLACE(AdcRegisters, cfgr2, ADC_TypeDef, CFGR2);
  SAME_PLACE(AdcRegisters, smpr, ADC_TypeDef, SMPR1);
  SAME_PLACE(AdcRegisters, tr, ADC_TypeDef, TR1);
  SAME_PLACE(AdcRegisters, sqr, ADC_TypeDef, SQR1);
  SAME_PLACE(AdcRegisters, dr, ADC_TypeDef, DR);
  SAME_PLACE(AdcRegisters, jsqr, ADC_TypeDef, JSQR);
  SAME_PLACE(AdcRegisters, ofr, ADC_TypeDef, OFR1);
  SAME_PLACE(AdcRegisters, jdr, ADC_TypeDef, JDR1);
  SAME_PLACE(AdcRegisters, awd2cr, ADC_TypeDef, AWD2CR);
  SAME_PLACE(AdcRegisters, difsel, ADC_TypeDef, DIFSEL);
  SAME_PLACE(AdcRegisters, calfact, ADC_TypeDef, CALFACT);
  SAME_PLACE(AdcCommonRegisters, csr, ADC_Common_TypeDef, CSR);
  SAME_PLACE(AdcCommonRegisters, ccr, ADC_Common_TypeDef, CCR);
  SAME_PLACE(AdcCommonRegisters, cdr, ADC_Common_TypeDef, CDR);
  SAME_PLACE(OpampRegisters, csr, OPAMP_TypeDef, CSR);
  SAME_PLACE(OpampRegisters, tcmr, OPAMP_TypeDef, TCMR);
  SAME_PLACE(FdcanRegisters, crel, FDCAN_GlobalTypeDef, CREL);
  SAME_PLACE(FdcanRegisters, endn, FDCAN_GlobalTypeDef, ENDN);
  SAME_PLACE(FdcanRegisters, dbtp, FDCAN_GlobalTypeDef, DBTP);
  SAME_PLACE(FdcanRegisters, test, FDCAN_GlobalTypeDef, TEST);
  SAME_PLACE(FdcanRegisters, rwd, FDCAN_GlobalTypeDef, RWD);
  SAME_PLACE(FdcanRegisters, cccr, FDCAN_GlobalTypeDef, CCCR);
  SAME_PLACE(FdcanRegisters, nbtp, FDCAN_GlobalTypeDef, NBTP);
  SAME_PLACE(FdcanRegisters, tscc, FDCAN_GlobalTypeDef, TSCC);
  SAME_PLACE(FdcanRegisters, tscv, FDCAN_GlobalTypeDef, TSCV);
  SAME_PLACE(FdcanRegisters, tocc, FDCAN_GlobalTypeDef, TOCC);
  SAME_PLACE(FdcanRegisters, tocv, FDCAN_GlobalTypeDef, TOCV);
  SAME_PLACE(FdcanRegisters, ecr, FDCAN_GlobalTypeDef, ECR);
  SAME_PLACE(FdcanRegisters, psr, FDCAN_GlobalTypeDef, PSR);
  SAME_PLACE(FdcanRegisters, tdcr, FDCAN_GlobalTypeDef, TDCR);
  SAME_PLACE(FdcanRegisters, ir, FDCAN_GlobalTypeDef, IR);
  SAME_PLACE(FdcanRegisters, ie, FDCAN_GlobalTypeDef, IE);
  SAME_PLACE(FdcanRegisters, ils, FDCAN_GlobalTypeDef, ILS);
  SAME_PLACE(FdcanRegisters, ile, FDCAN_GlobalTypeDef, ILE);
  SAME_PLACE(FdcanRegisters, rxgfc, FDCAN_GlobalTypeDef, RXGFC);
  SAME_PLACE(FdcanRegisters, xidam, FDCAN_GlobalTypeDef, XIDAM);
  SAME_PLACE(FdcanRegisters, hpms, FDCAN_GlobalTypeDef, HPMS);
  SAME_PLACE(FdcanRegisters, rxf0s, FDCAN_GlobalTypeDef, RXF0S);
  SAME_PLACE(FdcanRegisters, rxf0a, FDCAN_GlobalTypeDef, RXF0A);
  SAME_PLACE(FdcanRegisters, rxf1s, FDCAN_GlobalTypeDef, RXF1S);
  SAME_PLACE(FdcanRegisters, rxf1a, FDCAN_GlobalTypeDef, RXF1A);
  SAME_PLACE(FdcanRegisters, txbc, FDCAN_GlobalTypeDef, TXBC);
  SAME_PLACE(FdcanRegisters, txfqs, FDCAN_GlobalTypeDef, TXFQS);
  SAME_PLACE(FdcanRegisters, txbrp, FDCAN_GlobalTypeDef, TXBRP);
  SAME_PLACE(FdcanRegisters, txbar, FDCAN_GlobalTypeDef, TXBAR);
  SAME_PLACE(FdcanRegisters, txbcr, FDCAN_GlobalTypeDef, TXBCR);
  SAME_PLACE(FdcanRegisters, txbto, FDCAN_GlobalTypeDef, TXBTO);
  SAME_PLACE(FdcanRegisters, txbcf, FDCAN_GlobalTypeDef, TXBCF);
  SAME_PLACE(FdcanRegisters, txbtie, FDCAN_GlobalTypeDef, TXBTIE);
  SAME_PLACE(FdcanRegisters, txbcie, FDCAN_GlobalTypeDef, TXBCIE);
  SAME_PLACE(FdcanRegisters, txefs, FDCAN_GlobalTypeDef, TXEFS);
  SAME_PLACE(FdcanRegisters, txefa, FDCAN_GlobalTypeDef, TXEFA);
  SAME_PLACE(RngRegisters, cr, RNG_TypeDef, CR);
  SAME_PLACE(RngRegisters, sr, RNG_TypeDef, SR);
  SAME_PLACE(RngRegisters, dr, RNG_TypeDef, DR);
  SAME_PLACE(IwdgRegisters, kr, IWDG_TypeDef, KR);
  SAME_PLACE(IwdgRegisters, pr, IWDG_TypeDef, PR);
  SAME_PLACE(IwdgRegisters, rlr, IWDG_TypeDef, RLR);
  SAME_PLACE(IwdgRegisters, sr, IWDG_TypeDef, SR);
  SAME_PLACE(IwdgRegisters, winr, IWDG_TypeDef, WINR);
}

TEST(RegistersOfSt, Addresses) {
  SAME(addresses::kTim2, TIM2_BASE);
  SAME(addresses::kIwdg, IWDG_BASE);
  SAME(addresses::kFdcan1, FDCAN1_BASE);
  SAME(addresses::kPwr, PWR_BASE);
  SAME(addresses::kFdcan1MessageRam, SRAMCAN_BASE);
  SAME(addresses::kOpamp, OPAMP1_BASE);
  SAME(addresses::kTim1, TIM1_BASE);
  SAME(addresses::kRcc, RCC_BASE);
  SAME(addresses::kFlash, FLASH_R_BASE);
  SAME(addresses::kGpioA, GPIOA_BASE);
  SAME(addresses::kGpioB, GPIOB_BASE);
  SAME(addresses::kGpioC, GPIOC_BASE);
  SAME(addresses::kAdc1, ADC1_BASE);
  SAME(addresses::kAdc2, ADC2_BASE);
  SAME(addresses::kAdc12Common, ADC12_COMMON_BASE);
  SAME(addresses::kRng, RNG_BASE);
  SAME(addresses::kFlashArray, FLASH_BASE);
}

}  // namespace
